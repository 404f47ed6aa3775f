"""Constraint forces on the graph: multipliers of constraints, and reactions where bodies are cut.

Both are written in q, u and u', so that they hold whatever solves for u'. Multipliers λ follow from

    M u' = F + Jᵀ λ,        J: the constraints' derivatives by the speeds,

of which Kane's equations keep only what is free of λ. What M u' − F is, all speeds free, comes from
the outer bodies inwards as in the recursive Newton–Euler algorithm; the rows of the dependent
speeds give as many equations for λ as there are independent constraints. A reaction is the sum of
m a and of the change of angular momentum over the bodies on one side of the cut, less the loads on
them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise, permutations
from typing import Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import Point, Vector

from pydy._collector import collector_paused
from pydy._forks import cached_property
from pydy._graph import (
    NodeExpression,
    jacobian,
    rounding_bounds,
    signatures,
    substitute,
)
from pydy._mechanics.acceleration_constraints import multipliers_of
from pydy._mechanics.components import numbers_of, turned
from pydy._mechanics.elimination import composite
from pydy._mechanics.form import lagranges_equations, moving
from pydy._mechanics.frame_tree import FrameTree, distances, given_velocity, steps_to
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.inertia import euler, loads_and_inertias, newton
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reader import is_rigid
from pydy._rank import ROUNDED, is_zero


class ConstraintForces:
    """The forces behind the constraints and joints of a mechanism.

    Constraints are given as expressions by their places: the `holonomic` ones that velocity
    constraints enforce, and the other, `nonholonomic` ones, which together imply all velocity
    constraints; `redundant` ones follow from these.

    The methods take the noncontributing forces among the loads by name: they stand for what is
    computed here. Nothing else tells them from a load that has no part in the motion.
    """

    def __init__(
        self,
        body: Multibody,
        holonomic: dict[int, Any],
        nonholonomic: dict[int, Any],
        redundant: dict[int, Any],
    ) -> None:
        self.body, self.holonomic, self.nonholonomic = body, holonomic, nonholonomic
        self.redundant = redundant

    def __reduce__(self) -> tuple[Any, ...]:
        # Graphs and expressions are made again when they are asked for.
        return type(self), (self.body, self.holonomic, self.nonholonomic, self.redundant)

    @cached_property
    def _kinematics(self) -> Kinematics:
        return moving(self.body, in_bodies=True, driven=True)

    def multipliers(self, noncontributing: Iterable[Any] = ()) -> dict[Any, Any]:
        """λ of each constraint: symbols lambda0, lambda1, … to expressions in q, u and u'."""
        places = [*self.holonomic, *self.nonholonomic, *self.redundant]
        if not places:
            return {}
        names = [f"lambda{k}" for k in places]
        with collector_paused():
            nodes = self._without(noncontributing, self._multipliers)
        return {sm.Symbol(n): self._expression(k, n) for n, k in zip(names, nodes, strict=True)}

    @cached_property
    def _multipliers(self) -> Vec:
        kinematics = self._kinematics
        g, own = kinematics.graph, self.body.dependent_columns
        rest = self._unbalanced()
        rows = [
            *kinematics.dt(kinematics.read.all(self.holonomic.values())),
            *kinematics.read.all(self.nonholonomic.values()),
            *kinematics.read.all(self.redundant.values()),
        ]
        rank = len(own)
        if self.body.changing:  # no speed is dependent in all configurations
            own = tuple(range(len(kinematics.speeds)))
        bound = jacobian(g, rows, [kinematics.speeds[k] for k in own])
        columns = bound.dense()  # Jᵀ, by columns
        force = [g.neg(rest[k]) for k in own]
        if self.body.changing:
            found = multipliers_of(g, columns, force, rank)
        elif len(columns) == len(own):
            found = g.solve([list(row) for row in zip(*columns, strict=True)], [force], "lu")[0]
        else:
            found = self._shortest(columns, force)
        return found

    def unbalanced(self, noncontributing: Iterable[Any] = ()) -> list[Any]:
        """F − M u' of each speed, which Jᵀ λ balances: expressions in q, u and u'."""
        with collector_paused():
            nodes = self._without(noncontributing, self._unbalanced())
        return [self._expression(node, f"force{k}") for k, node in enumerate(nodes)]

    def _unbalanced(self) -> Vec:
        """Return F − M u' with all speeds free."""
        kinematics = self._kinematics
        if self.body.lagrangian is not None:
            return lagranges_equations(kinematics)[1]
        return composite(kinematics, [], loads_and_inertias(kinematics)[1])[1]

    def _shortest(self, columns: Sequence[Vec], force: Vec) -> Vec:
        """Return the least multipliers where more constraints than are independent share a force.

        With A = Jᵀ, λ = Aᵀ (A Aᵀ)⁻¹ f.
        """
        g, d = self._kinematics.graph, len(force)
        square = [
            [g.sum([(g.mul(c[i], c[j]), 1.0) for c in columns]) for j in range(d)] for i in range(d)
        ]
        share = g.solve(square, [force], "ldl")[0]
        return turned(g, columns, share)

    def reaction(
        self,
        members: Iterable[Any],
        point: Any,
        frame: Any,
        loads: Iterable[tuple[Any, Any]],
        name: str,
        noncontributing: Iterable[Any] = (),
    ) -> tuple[Vector, Vector]:
        """Return force and torque about a point that hold some bodies, besides the loads.

        The `members` are these bodies, and massless points and frames whose loads act on them;
        further `loads` are pairs of a Point or ReferenceFrame and a Vector. The components are in
        the `frame`; the expressions are printed by a `name`.
        """
        members = list(members)
        kinematics = self._kinematics
        with collector_paused():
            force, torque = _balance(
                kinematics,
                point,
                frame,
                [b for b in self.body.bodies if b in members],
                [*self._loads_on(members), *loads],
            )
            nodes = self._without(noncontributing, [*force, *torque])
        values = [
            self._expression(n, f"{name}_{part}{axis}")
            for n, (part, axis) in zip(nodes, [(p, a) for p in "FT" for a in "xyz"], strict=True)
        ]
        return (
            Vector([(sm.Matrix(values[:3]), frame)]),
            Vector([(sm.Matrix(values[3:]), frame)]),
        )

    def _loads_on(self, members: Sequence[Any]) -> list[tuple[Any, Any]]:
        """Return the loads on bodies: at points and frames that move with them and no other."""
        return [
            (where, vector)
            for where, vector in self.body.loads
            if where in members
            or (self._owners[where] and all(owner in members for owner in self._owners[where]))
        ]

    @cached_property
    def _owners(self) -> dict[Any, list[Any]]:
        """The bodies that each load's point or frame moves with, or the inertial frame."""
        k, bodies = self._kinematics, self.body.bodies
        found = {w: [b for b in bodies if b.masscenter is w] for w, _ in self.body.loads}
        still, rest, rigid = {}, [], [b for b in bodies if is_rigid(b)]
        for where in (w for w, own in found.items() if isinstance(w, Point) and not own):
            line = self._located_by(where)
            at_rest = all(n == k.graph.zero for n in k.at(where)[1])
            if at_rest and not any(b.masscenter in line for b in rigid):
                steps = [FrameTree.positions(p)[before] for p, before in pairwise(line)]
                still[where] = {f for step in steps for _, f in step.args}
            else:
                rest.append(where)
        turning = [w for w in found if not isinstance(w, Point)]
        everywhere = [*turning, *(f for frames in still.values() for f in frames)]
        fixed = self._fixed_to(list(dict.fromkeys(everywhere)))
        found |= {frame: fixed[frame] for frame in turning}
        for where, frames in still.items():
            if all(fixed[f] == [k.inertial] for f in frames):
                found[where] = [k.inertial]
            else:
                rest.append(where)
        pairs = [(where, body) for where in rest for body in bodies]
        carried = self._vanishing([self._slip(body, where) for where, body in pairs])
        along: dict[Any, list[Any]] = {where: [] for where in rest}
        for (where, body), moves_along in zip(pairs, carried, strict=True):
            if moves_along:
                along[where].append(body)
        return found | {where: self._without_welded(where, own) for where, own in along.items()}

    def _without_welded(self, point: Any, bodies: Sequence[Any]) -> list[Any]:
        """Leave out bodies that are welded to another one from which a point is fewer steps away.

        At a hinge are two bodies as well, which turn in different ways.
        """
        away = distances(point, FrameTree.positions) if len(bodies) > 1 else {}
        pairs = [
            (far, [self._spin(near.frame), self._spin(far.frame, -1.0)])
            for near, far in permutations(bodies, 2)
            if away[near.masscenter] < away[far.masscenter] and is_rigid(near) and is_rigid(far)
        ]
        welded = self._vanishing([spins for _, spins in pairs])
        left = [far for (far, _), same in zip(pairs, welded, strict=True) if same]
        return [body for body in bodies if body not in left]

    def _located_by(self, point: Any) -> list[Any]:
        """Return a point, the one it was located from, and so on, as far as their order tells."""
        line = [point]
        while (before := next(iter(FrameTree.positions(point)), None)) not in (None, *line):
            first = next(iter(FrameTree.positions(before))) is point
            if first and given_velocity(point, self.body.frame) is not None:
                break
            line.append(before)
            point = before
        return line

    def _fixed_to(self, frames: Sequence[Any]) -> dict[Any, list[Any]]:
        """Return the bodies that turn like each frame: of several, the nearest ones.

        A carriage turns as the ground does.
        """
        k = self._kinematics
        rigid = [
            (b.frame, b) for b in self.body.bodies if is_rigid(b) and b.frame is not k.inertial
        ]
        rigid.append((k.inertial, k.inertial))
        pairs = [(frame, *both) for frame in frames for both in rigid]
        slips = [[self._spin(own), self._spin(f, -1.0)] for f, own, _ in pairs]
        alike: dict[Any, list[Any]] = {frame: [] for frame in frames}
        for (frame, own, body), same in zip(pairs, self._vanishing(slips), strict=True):
            if same or own is frame:
                alike[frame].append((own, body))
        found = {}
        for frame, both in alike.items():
            away = distances(frame, FrameTree.orientations)
            nearest = min((away[own] for own, _ in both), default=0)
            found[frame] = [body for own, body in both if away[own] == nearest]
        return found

    def _spin(self, frame: Any, sign: float = 1.0) -> Vec:
        """Return an angular velocity in the inertial frame."""
        k = self._kinematics
        w = k.expressed(k.spin(frame)[0], k.frames.axes(frame), k.inertial)
        return [k.graph.sum([(n, sign)]) for n in w]

    def _slip(self, body: Any, point: Any) -> list[Vec]:
        """Return vectors whose sum is zero if a point moves as a point of the body would."""
        k, g = self._kinematics, self._kinematics.graph
        away = distances(body.masscenter, FrameTree.positions)
        if point not in away:
            return [[g.one] * 3]
        ways = [k.vector(step, k.inertial) for step in steps_to(point, away)]
        if not is_rigid(body):
            return ways
        ours, theirs = (
            k.expressed(v, frame, k.inertial) for frame, v in map(k.at, (body.masscenter, point))
        )
        spin = self._spin(body.frame)
        return [ours, [g.neg(n) for n in theirs], *(k.cross(spin, way) for way in ways)]

    def _vanishing(self, sums: Sequence[Sequence[Vec]]) -> list[bool]:
        """Return whether sums of vectors are zero in all states, up to rounding.

        Numbers that users write in decimals are rounded, and so are their sums.
        """
        flat = [n for vectors in sums for v in vectors for n in v]
        if not flat:
            return [True] * len(sums)
        k = self._kinematics
        held = orthogonality_residuals(k.tree.rotation_matrices(), k.read)
        values = numbers_of(k.graph, flat, held)
        values, found = values.reshape(len(values), -1, 3), []
        for vectors in sums:
            own, values = values[:, : len(vectors)], values[:, len(vectors) :]
            sizes = np.linalg.norm(own, axis=2).sum(axis=1)
            found.append(bool((np.linalg.norm(own.sum(axis=1), axis=1) <= ROUNDED * sizes).all()))
        left = [vectors for vectors, zero in zip(sums, found, strict=True) if zero]
        closer = iter(self._vanishing_near_zero(left, held))
        return [zero and next(closer) for zero in found]

    def _vanishing_near_zero(
        self, sums: Sequence[Sequence[Vec]], held: Sequence[int]
    ) -> list[bool]:
        """Return whether sums of vectors are zero where coordinates are, by each speed alone.

        Beside coordinates and speeds of size one, offsets of nanometres may be lost in rounding.
        """
        if not sums:
            return []
        k, g = self._kinematics, self._kinematics.graph
        totals = [k.plus(*vectors)[axis] for vectors in sums for axis in range(3)]
        rows = jacobian(g, totals, k.speeds).dense()
        still = substitute(g, totals, dict.fromkeys(k.speeds, g.zero))
        nodes = [n for row, rest in zip(rows, still, strict=True) for n in (*row, rest)]
        values = numbers_of(g, [*nodes, *rounding_bounds(g, nodes)], held, k.coordinates)
        lost, bounds = np.abs(values).reshape(len(values), 2, len(sums), -1).swapaxes(0, 1)
        # What has no value there is left to the other states.
        zero = is_zero(lost, bounds) | ~np.isfinite(lost)
        return [bool(z) for z in zero.all(axis=(0, 2))]

    def _without(self, forces: Iterable[Any], nodes: Vec) -> Vec:
        g, atoms = self._kinematics.graph, self._kinematics.read.atoms
        nodes = substitute(g, nodes, {atoms[s]: g.zero for s in forces if s in atoms})
        values = signatures(g, nodes)
        return [node if value else g.zero for node, value in zip(nodes, values, strict=True)]

    def _expression(self, node: int, name: str) -> Any:
        g = self._kinematics.graph
        if node == g.zero:
            return sm.S.Zero
        return NodeExpression.of(g, node, self._kinematics.symbols(), name)


def _balance(
    k: Kinematics, point: Any, frame: Any, bodies: Iterable[Any], loads: Iterable[tuple[Any, Any]]
) -> tuple[Vec, Vec]:
    """Return force and torque about a point by Newton's and Euler's laws: beyond the loads."""
    pushes: list[tuple[Any, Vec]] = []
    couples: list[Vec] = []
    for body in bodies:
        if (moved := newton(k, body)) is not None:
            pushes.append((body.masscenter, k.expressed(moved[3], moved[0], frame)))
        if (turned := euler(k, body)) is not None:
            couples.append(k.expressed(turned[3], turned[0], frame))
    for where, vector in loads:
        opposite = [k.graph.neg(n) for n in k.vector(vector, frame)]
        if isinstance(where, Point):
            pushes.append((where, opposite))
        else:
            couples.append(opposite)
    couples += [k.cross(k.vector(p.pos_from(point), frame), force) for p, force in pushes]
    nothing = [k.graph.zero] * 3
    return k.plus(nothing, *(force for _, force in pushes)), k.plus(nothing, *couples)
