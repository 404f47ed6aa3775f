"""Constraint forces on the graph: multipliers of constraints, and reactions where bodies are cut.

Both are expressions in q, u and u', so that they do not depend on how u' is computed. Multipliers λ
follow from

    M u' = F + Jᵀ λ,        J: derivatives of the constraints with respect to the speeds,

from which Kane's equations eliminate λ. M u' − F with all speeds free is computed from the outer
bodies inwards, as in the recursive Newton–Euler algorithm; the rows of the dependent speeds give
one equation for each independent constraint. A reaction is the sum of m a and of the rate of
angular momentum over the bodies on one side of the cut, minus the loads on them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import combinations, pairwise, permutations
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm
from sympy.physics.mechanics import Point, Vector

from pydy._collector import collector_paused
from pydy._forks import cached_property
from pydy._graph import (
    LinearSystem,
    NodeExpression,
    jacobian,
    rounding_bounds,
    signatures,
    substitute,
)
from pydy._mechanics.acceleration_constraints import multipliers_of
from pydy._mechanics.components import numbers_of, product
from pydy._mechanics.elimination import composite
from pydy._mechanics.formulations import lagranges_equations, moving
from pydy._mechanics.frame_tree import FrameTree, distances, given_velocity, steps_to
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.inertia import euler, loads_and_inertias, newton
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reader import is_rigid
from pydy._rank import ROUNDED, is_zero

if TYPE_CHECKING:
    from sympy.physics.mechanics import ReferenceFrame

    from pydy._mechanics.cuts import Motions
    from pydy._sympy_types import AnySymbol, Body, Load, Location


class ConstraintForces:
    """The forces behind the constraints and joints of a mechanism.

    Constraints are expressions by number: the `holonomic` ones that velocity constraints enforce,
    and the `nonholonomic` ones, which together imply all velocity constraints; the `redundant` ones
    follow from these.

    The methods take the names of the noncontributing forces among the loads. These symbols stand
    for the forces that are computed here, and cannot be told from ordinary loads otherwise.
    """

    def __init__(
        self,
        body: Multibody,
        holonomic: dict[int, sm.Expr],
        nonholonomic: dict[int, sm.Expr],
        redundant: dict[int, sm.Expr],
    ) -> None:
        self.body, self.holonomic, self.nonholonomic = body, holonomic, nonholonomic
        self.redundant = redundant

    def __reduce__(self) -> tuple[type[ConstraintForces], tuple[object, ...]]:
        # Graphs and expressions are rebuilt on demand.
        return type(self), (self.body, self.holonomic, self.nonholonomic, self.redundant)

    @cached_property
    def _kinematics(self) -> Kinematics:
        return moving(self.body, in_bodies=True, driven=True)

    def multipliers(self, noncontributing: Iterable[AnySymbol] = ()) -> dict[sm.Symbol, sm.Expr]:
        """λ of each constraint: symbols lambda0, lambda1, … to expressions in q, u and u'."""
        positions = [*self.holonomic, *self.nonholonomic, *self.redundant]
        if not positions:
            return {}
        names = [f"lambda{k}" for k in positions]
        with collector_paused():
            nodes = self._neglecting(noncontributing, self._multipliers)
        return {sm.Symbol(n): self._expression(k, n) for n, k in zip(names, nodes, strict=True)}

    @cached_property
    def _multipliers(self) -> Vec:
        kinematics = self._kinematics
        g, dependent = kinematics.graph, self.body.dependents.speed_columns
        unbalanced = self._unbalanced()
        rank = len(dependent)
        if self.body.dependents.changing:  # no speed is dependent in all configurations
            dependent = tuple(range(len(kinematics.speeds)))
        bound = jacobian(g, self._rates, [kinematics.speeds[k] for k in dependent])
        columns = bound.dense()  # Jᵀ, by columns
        force = [g.neg(unbalanced[k]) for k in dependent]
        if self.body.dependents.changing:
            multipliers = multipliers_of(g, columns, force, rank)
        elif len(columns) == len(dependent):
            transposed = [list(row) for row in zip(*columns, strict=True)]
            multipliers = LinearSystem(g, transposed).solve(force)
        else:
            multipliers = self._shortest(columns, force)
        return multipliers

    @cached_property
    def _rates(self) -> Vec:
        """The velocities that the constraints hold at zero."""
        k = self._kinematics
        return [
            *k.dt(k.read.all(self.holonomic.values())),
            *k.read.all(self.nonholonomic.values()),
            *k.read.all(self.redundant.values()),
        ]

    def unbalanced(self, noncontributing: Iterable[AnySymbol] = ()) -> list[sm.Expr]:
        """F − M u' of each speed, which Jᵀ λ balances: expressions in q, u and u'."""
        with collector_paused():
            nodes = self._neglecting(noncontributing, self._unbalanced())
        return [self._expression(node, f"force{k}") for k, node in enumerate(nodes)]

    def _unbalanced(self) -> Vec:
        """Return F − M u' with all speeds free."""
        kinematics = self._kinematics
        if self.body.lagrangian is not None:
            return lagranges_equations(kinematics)[1]
        return composite(kinematics, [], loads_and_inertias(kinematics)[1])[1]

    def _shortest(self, columns: Sequence[Vec], force: Vec) -> Vec:
        """Return the multipliers of least norm if there are redundant constraints.

        With A = Jᵀ, λ = Aᵀ (A Aᵀ)⁻¹ f.
        """
        g, d = self._kinematics.graph, len(force)
        square = [
            [g.sum([(g.mul(c[i], c[j]), 1.0) for c in columns]) for j in range(d)] for i in range(d)
        ]
        share = LinearSystem(g, square, "ldl").solve(force)
        return product(g, columns, share)

    def reaction(
        self,
        members: Iterable[Body | Location],
        point: Point,
        frame: ReferenceFrame,
        loads: Iterable[Load],
        name: str,
        noncontributing: Iterable[AnySymbol] = (),
    ) -> tuple[Vector, Vector]:
        """Return the reaction force, and the torque about a point, on a group of bodies.

        The `members` are these bodies, and massless points and frames whose loads act on them;
        further `loads` are pairs of a Point or ReferenceFrame and a Vector. The components are in
        the `frame`; `name` labels the expressions.
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
            nodes = self._neglecting(noncontributing, [*force, *torque])
        values = [
            self._expression(n, f"{name}_{part}{axis}")
            for n, (part, axis) in zip(nodes, [(p, a) for p in "FT" for a in "xyz"], strict=True)
        ]
        return (
            Vector([(sm.Matrix(values[:3]), frame)]),
            Vector([(sm.Matrix(values[3:]), frame)]),
        )

    def further_joints(
        self, members: Iterable[Body | Location], point: Point, known: Iterable[Point] = ()
    ) -> tuple[bool, list[str]]:
        """Return whether a group of bodies is joined to others elsewhere than at a point.

        By the coordinates, and by constraints, of which the names of the multipliers are returned,
        except those of joints at `known` points. See `pydy._mechanics.cuts`.
        """
        from pydy._mechanics.cuts import Cut, further_joints  # what only reactions need

        members = list(members)
        positions = [*self.holonomic, *self.nonholonomic, *self.redundant]
        inside = [b for b in self.body.bodies if b in members]
        outside = [b for b in self.body.bodies if b not in members]
        ends: list[Body | None] = [*self.body.bodies, None]
        points = [point, *known]
        with collector_paused():
            slips = [self._slip_at(body, inside[0], at) for at in points for body in ends]
            moves = iter(self._vanishing(slips))
            carriers = [[body for body in ends if next(moves)] for _ in points]
            sides = [
                ([b for b in inside if b in moving], [b for b in moving if b not in inside])
                for moving in carriers
            ]
            cut = Cut(inside, outside, *sides[0], sides[1:])
            joined, across = further_joints(self._motions, cut)
        return joined, [f"lambda{positions[j]}" for j in across]

    @cached_property
    def _motions(self) -> Motions:
        from pydy._mechanics.cuts import Motions

        k = self._kinematics
        holonomic = k.read.all(self.holonomic.values())
        return Motions(k, self._rates, holonomic, self.body.bodies)

    def _slip_at(self, body: Body | None, near: Body, point: Point) -> list[Vec]:
        """Return vectors whose sum is zero if any point moves with a body, or with the ground."""
        k = self._kinematics
        centre = near.masscenter if body is None else body.masscenter
        offset = k.vector(point.pos_from(centre), k.inertial)
        if body is None:
            home, v = k.velocity_of(centre)
            return [k.dt(offset), k.expressed(v, home, k.inertial)]
        if not is_rigid(body):
            return [offset]
        turned = k.cross(self._spin(body.frame), offset)
        return [k.dt(offset), [k.graph.neg(n) for n in turned]]

    def _loads_on(self, members: Sequence[Body | Location]) -> list[Load]:
        """Return the loads at points and frames that move with these bodies and no others."""
        return [
            (location, vector)
            for location, vector in self.body.loads
            if location in members
            or (
                self._owners[location] and all(owner in members for owner in self._owners[location])
            )
        ]

    @cached_property
    def _owners(self) -> dict[Location, list[Body | ReferenceFrame]]:
        """The bodies, or the inertial frame, that the point or frame of each load is fixed to."""
        k, bodies = self._kinematics, self.body.bodies
        owners = {w: [b for b in bodies if b.masscenter is w] for w, _ in self.body.loads}
        frames_on_the_way, undecided, rigid = {}, [], [b for b in bodies if is_rigid(b)]
        for location in (
            w for w, bodies_there in owners.items() if isinstance(w, Point) and not bodies_there
        ):
            line = self._located_by(location)
            at_rest = all(n == k.graph.zero for n in k.velocity_of(location)[1])
            if at_rest and not any(b.masscenter in line for b in rigid):
                steps = [FrameTree.positions(p)[before] for p, before in pairwise(line)]
                frames_on_the_way[location] = {f for step in steps for _, f in step.args}
            else:
                undecided.append(location)
        turning = [w for w in owners if not isinstance(w, Point)]
        everywhere = [*turning, *(f for frames in frames_on_the_way.values() for f in frames)]
        fixed = self._fixed_to(list(dict.fromkeys(everywhere)))
        owners |= {frame: fixed[frame] for frame in turning}
        for location, frames in frames_on_the_way.items():
            if all(fixed[f] == [k.inertial] for f in frames):
                owners[location] = [k.inertial]
            else:
                undecided.append(location)
        pairs = [(location, body) for location in undecided for body in bodies]
        follows = self._vanishing([self._slip(body, location) for location, body in pairs])
        carriers: dict[Point, list[Body]] = {location: [] for location in undecided}
        for (location, body), moves_along in zip(pairs, follows, strict=True):
            if moves_along:
                carriers[location].append(body)
        return owners | {
            location: self._without_welded(location, bodies_there)
            for location, bodies_there in carriers.items()
        }

    def uncounted(
        self, members: Iterable[Body | Location], point: Point, further: Iterable[Location]
    ) -> list[ReferenceFrame]:
        """Return the frames of massless links beyond a cut whose torques are not counted.

        No rigid body turns with such a frame. It turns with the line between two particles beyond
        the cut, or from the point of the cut to one that is located from there. No particle outside
        is fixed to it as well. Frames among the `members` or the locations of `further` loads
        count, and torques that cancel have no effect.
        """
        members, further, k = list(members), list(further), self._kinematics
        frames = [
            frame
            for frame, owners in self._owners.items()
            if not (isinstance(frame, Point) or owners or frame in members or frame in further)
        ]
        if not frames:
            return []
        particles = [b for b in self.body.bodies if not is_rigid(b)]
        inside = [b.masscenter for b in particles if b in members]
        outside = [b.masscenter for b in particles if b not in members and b.masscenter != point]
        near = distances(point, FrameTree.positions)
        pairs = [*combinations(inside, 2), *((point, end) for end in inside if near[end] == 1)]
        links = []
        for frame in frames:
            ends = {end for pair in self._turning_with(frame, pairs) for end in pair}
            across = [(end, far) for end in ends for far in outside]
            if ends and not self._turning_with(frame, across):
                links.append(frame)
        torques = [k.vector(v, k.inertial) for frame, v in self.body.loads if frame in links]
        return [] if self._vanishing([torques])[0] else links

    def _turning_with(
        self, frame: ReferenceFrame, pairs: Sequence[tuple[Point, Point]]
    ) -> list[tuple[Point, Point]]:
        """Return the pairs of points whose distance is fixed in a frame, and not on its axis."""
        k, spin = self._kinematics, self._spin(frame)
        arms = [k.vector(end.pos_from(start), k.inertial) for start, end in pairs]
        turned = [k.cross(spin, arm) for arm in arms]
        slips = [
            [k.dt(arm), [k.graph.neg(n) for n in v]] for arm, v in zip(arms, turned, strict=True)
        ]
        fixed, still = self._vanishing(slips), self._vanishing([[v] for v in turned])
        return [pair for pair, f, s in zip(pairs, fixed, still, strict=True) if f and not s]

    def _without_welded(self, point: Point, bodies: Sequence[Body]) -> list[Body]:
        """Drop bodies that are welded to another body to which the point is nearer.

        At a hinge there are two bodies as well, but with different angular velocities.
        """
        away = distances(point, FrameTree.positions) if len(bodies) > 1 else {}
        pairs = [
            (far, [self._spin(near.frame), self._spin(far.frame, -1.0)])
            for near, far in permutations(bodies, 2)
            if away[near.masscenter] < away[far.masscenter] and is_rigid(near) and is_rigid(far)
        ]
        welded = self._vanishing([spins for _, spins in pairs])
        dropped = [far for (far, _), same in zip(pairs, welded, strict=True) if same]
        return [body for body in bodies if body not in dropped]

    def _located_by(self, point: Point) -> list[Point]:
        """Return a point, the point that it was located from, and so on, in order of definition."""
        line = [point]
        while (before := next(iter(FrameTree.positions(point)), None)) not in (None, *line):
            first = next(iter(FrameTree.positions(before))) is point
            if first and given_velocity(point, self.body.frame) is not None:
                break
            line.append(before)
            point = before
        return line

    def _fixed_to(
        self, frames: Sequence[ReferenceFrame]
    ) -> dict[ReferenceFrame, list[Body | ReferenceFrame]]:
        """Return the nearest bodies that have the angular velocity of each frame.

        A carriage, for instance, has that of the ground.
        """
        k = self._kinematics
        rigid = [
            (b.frame, b) for b in self.body.bodies if is_rigid(b) and b.frame is not k.inertial
        ]
        rigid.append((k.inertial, k.inertial))
        pairs = [(frame, *pair) for frame in frames for pair in rigid]
        slips = [[self._spin(body_frame), self._spin(f, -1.0)] for f, body_frame, _ in pairs]
        alike: dict[ReferenceFrame, list[tuple[ReferenceFrame, Body | ReferenceFrame]]] = {
            frame: [] for frame in frames
        }
        for (frame, body_frame, body), same in zip(pairs, self._vanishing(slips), strict=True):
            if same or body_frame is frame:
                alike[frame].append((body_frame, body))
        fixed = {}
        for frame, matches in alike.items():
            away = distances(frame, FrameTree.orientations)
            nearest = min((away[body_frame] for body_frame, _ in matches), default=0)
            fixed[frame] = [body for body_frame, body in matches if away[body_frame] == nearest]
        return fixed

    def _spin(self, frame: ReferenceFrame, sign: float = 1.0) -> Vec:
        """Return an angular velocity in the inertial frame."""
        k = self._kinematics
        w = k.expressed(k.spin(frame)[0], k.frames.axes(frame), k.inertial)
        return [k.graph.sum([(n, sign)]) for n in w]

    def _slip(self, body: Body, point: Point) -> list[Vec]:
        """Return vectors whose sum is zero if a point moves with the body."""
        k, g = self._kinematics, self._kinematics.graph
        away = distances(body.masscenter, FrameTree.positions)
        if point not in away:
            return [[g.one] * 3]
        offsets = [k.vector(step, k.inertial) for step in steps_to(point, away)]
        if not is_rigid(body):
            return offsets
        ours, theirs = (
            k.expressed(v, frame, k.inertial)
            for frame, v in map(k.velocity_of, (body.masscenter, point))
        )
        spin = self._spin(body.frame)
        return [ours, [g.neg(n) for n in theirs], *(k.cross(spin, offset) for offset in offsets)]

    def _vanishing(self, sums: Sequence[Sequence[Vec]]) -> list[bool]:
        """Return which sums of vectors vanish in all states, up to the rounding of decimals."""
        flat = [n for vectors in sums for v in vectors for n in v]
        if not flat:
            return [True] * len(sums)
        k = self._kinematics
        zero_rows = orthogonality_residuals(k.tree.rotation_matrices(), k.read)
        values = numbers_of(k.graph, flat, zero_rows)
        values, vanishing = values.reshape(len(values), -1, 3), []
        for vectors in sums:
            group, values = values[:, : len(vectors)], values[:, len(vectors) :]
            sizes = np.linalg.norm(group, axis=2).sum(axis=1)
            vanishing.append(
                bool((np.linalg.norm(group.sum(axis=1), axis=1) <= ROUNDED * sizes).all())
            )
        candidates = [vectors for vectors, zero in zip(sums, vanishing, strict=True) if zero]
        closer = iter(self._vanishing_near_zero(candidates, zero_rows))
        return [zero and next(closer) for zero in vanishing]

    def _vanishing_near_zero(
        self, sums: Sequence[Sequence[Vec]], zero_rows: Sequence[int]
    ) -> list[bool]:
        """Return which sums of vectors vanish at zero coordinates, for each speed alone.

        With coordinates and speeds of order one, offsets of nanometres could be lost in rounding.
        """
        if not sums:
            return []
        k, g = self._kinematics, self._kinematics.graph
        totals = [k.plus(*vectors)[axis] for vectors in sums for axis in range(3)]
        rows = jacobian(g, totals, k.speeds).dense()
        at_rest = substitute(g, totals, dict.fromkeys(k.speeds, g.zero))
        nodes = [
            n for row, node_at_rest in zip(rows, at_rest, strict=True) for n in (*row, node_at_rest)
        ]
        values = numbers_of(g, [*nodes, *rounding_bounds(g, nodes)], zero_rows, k.coordinates)
        sizes, bounds = np.abs(values).reshape(len(values), 2, len(sums), -1).swapaxes(0, 1)
        # Values that are not finite there are judged at the other states.
        zero = is_zero(sizes, bounds) | ~np.isfinite(sizes)
        return [bool(z) for z in zero.all(axis=(0, 2))]

    def _neglecting(self, forces: Iterable[AnySymbol], nodes: Vec) -> Vec:
        """Return nodes with these forces set to zero."""
        g, atoms = self._kinematics.graph, self._kinematics.read.atoms
        nodes = substitute(g, nodes, {atoms[s]: g.zero for s in forces if s in atoms})
        values = signatures(g, nodes)
        return [node if value else g.zero for node, value in zip(nodes, values, strict=True)]

    def _expression(self, node: int, name: str) -> sm.Expr:
        g = self._kinematics.graph
        if node == g.zero:
            return sm.S.Zero
        return NodeExpression.of(g, node, self._kinematics.symbols(), name)


def _balance(
    k: Kinematics,
    point: Point,
    frame: ReferenceFrame,
    bodies: Iterable[Body],
    loads: Iterable[Load],
) -> tuple[Vec, Vec]:
    """Return Newton's force and Euler's torque about a point, minus the loads."""
    pushes: list[tuple[Point, Vec]] = []
    couples: list[Vec] = []
    for body in bodies:
        if (translational := newton(k, body)) is not None:
            pushes.append((body.masscenter, k.expressed(translational[3], translational[0], frame)))
        if (rotational := euler(k, body)) is not None:
            couples.append(k.expressed(rotational[3], rotational[0], frame))
    for location, vector in loads:
        opposite = [k.graph.neg(n) for n in k.vector(vector, frame)]
        if isinstance(location, Point):
            pushes.append((location, opposite))
        else:
            couples.append(opposite)
    couples += [k.cross(k.vector(p.pos_from(point), frame), force) for p, force in pushes]
    nothing = [k.graph.zero] * 3
    return k.plus(nothing, *(force for _, force in pushes)), k.plus(nothing, *couples)
