"""Frames and points of SymPy: relative orientations and positions as the user gave them.

The only module that reads the private attributes of SymPy's vector classes.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, TypeAlias, TypeVar

import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._forks import cached_property

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point, ReferenceFrame, Vector

    from pydy._sympy_types import Body, Location

# The point from which a point is reached, None for a root, and the vectors on the way.
BaseAndSteps: TypeAlias = "tuple[Point | None, tuple[Vector, ...]]"

Item = TypeVar("Item")


class Axes:
    """Axes that are not a frame of the user."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __repr__(self) -> str:
        return self.name


# A frame of the user, or axes that were inserted between two of them (`pydy._mechanics.alignment`).
AnyFrame: TypeAlias = "ReferenceFrame | Axes"


class FrameTree:
    """Frames and points as the user related them to one another, seen from an inertial frame."""

    def __init__(self, inertial: ReferenceFrame) -> None:
        self.inertial = inertial

    # -- frames -----------------------------------------------------------------------------------

    @staticmethod
    def orientations(frame: ReferenceFrame) -> dict[ReferenceFrame, sm.Matrix]:
        """Return the frames that a frame is oriented in or relative to it, with the matrices."""
        related: dict[ReferenceFrame, sm.Matrix] = frame._dcm_dict
        return related

    @cached_property
    def frame_depth(self) -> dict[AnyFrame, int]:
        """The frames with an orientation, by their number of rotations from the inertial frame."""
        return distances(self.inertial, self.orientations)

    def rotation_matrices(self) -> list[sm.Matrix]:
        """Return the matrices of all orientations, from the inertial frame outwards."""
        depth = self.frame_depth
        pairs = [
            (matrix, depth[neighbour] > depth[frame])
            for frame in depth
            for neighbour, matrix in self.orientations(frame).items()
        ]
        return [m.as_immutable() for m, outwards in pairs if outwards]  # one may be the user's own

    @cached_property
    def spin_depth(self) -> dict[ReferenceFrame, int]:
        """The frames with an angular velocity, by their number of steps from the inertial frame."""
        return distances(self.inertial, lambda f: f._ang_vel_dict)

    def parent(self, frame: ReferenceFrame) -> ReferenceFrame | None:
        """Return the parent of a frame; None for the inertial frame."""
        if frame not in self.frame_depth:
            raise ValueError(
                f"The frame {frame} has no orientation in the inertial frame {self.inertial}. "
                f"Orient it, or one of the frames that it is oriented in: `{frame}.orient_axis("
                f"{self.inertial}, ...)`."
            )
        return _nearer(frame, frame._dcm_dict, self.frame_depth)

    def turns_in(self, frame: ReferenceFrame) -> ReferenceFrame | None:
        """Return the frame in which a frame's angular velocity is given, None for the inertial."""
        if frame not in self.spin_depth:
            self.parent(frame)  # a more specific error if it has no orientation
            raise ValueError(
                f"The frame {frame} has no angular velocity in the inertial frame "
                f"{self.inertial}. Give it one: `{frame}.set_ang_vel({self.inertial}, ...)`."
            )
        return _nearer(frame, frame._ang_vel_dict, self.spin_depth)

    @staticmethod
    def rotation(frame: ReferenceFrame, parent: ReferenceFrame) -> sm.Matrix:
        """Return the matrix from components in the parent to those in a frame."""
        return frame._dcm_dict[parent]

    @staticmethod
    def relative_spin(frame: ReferenceFrame, base: ReferenceFrame) -> Vector:
        """Return the angular velocity that was given between two frames."""
        return frame._ang_vel_dict[base]

    def angular_acceleration(self, frame: ReferenceFrame) -> Vector | None:
        """Return the angular acceleration that the user set in the inertial frame, or None."""
        return frame._ang_acc_dict.get(self.inertial)

    # -- points -----------------------------------------------------------------------------------

    @staticmethod
    def positions(point: Point) -> dict[Point, Vector]:
        """Return the points located relative to one, with the vectors from them to this one."""
        related: dict[Point, Vector] = point._pos_dict
        return related

    @staticmethod
    def points_from(points: Sequence[Point]) -> dict[Point, Point | None]:
        """Return points and all that are located from them, nearest first, with the point before.

        That is None for the points themselves.
        """
        return breadth_first(points, FrameTree.positions)

    @staticmethod
    def point_at_rest(frame: ReferenceFrame, points: Iterable[Point]) -> Point | None:
        """Return the nearest point with zero velocity that is connected to some points, or None."""
        for point in FrameTree.points_from([*points]):
            if given_velocity(point, frame) == 0:
                return point
        return None

    def velocity(self, point: Point) -> Vector | None:
        """Return the velocity that the user set, or None."""
        return given_velocity(point, self.inertial)

    def acceleration(self, point: Point) -> Vector | None:
        """Return the acceleration that the user set, or None."""
        return point._acc_dict.get(self.inertial)

    def paths(
        self, points: Iterable[Point], roles: Mapping[Location, str]
    ) -> dict[Point, BaseAndSteps]:
        """Return for each point its base and the vectors from there, (None, ()) for roots.

        The base moves independently of the point, so that a given velocity can be compared with the
        rate of the position. A velocity whose components are speeds is as simple as possible: such
        a point is a root. A point without a velocity is located from the nearest with one, as in
        SymPy.
        """
        targets = list(dict.fromkeys(points))
        reached = list(self.points_from(targets))
        velocities = {p: v for p in reached if (v := self.velocity(p)) is not None}
        with_velocity = list(velocities)
        simple = sorted(with_velocity, key=lambda p: len(velocities[p].args) > 0)
        if simple and velocities[simple[0]].args:
            simple = sorted(with_velocity, key=lambda p: _length(velocities[p]))
        nearest = self.points_from(with_velocity)
        rank: dict[Point, int] = {}
        above: dict[Point, Point | None] = {}
        for root in simple:
            if root in rank:
                continue
            for point, base in self.points_from([root]).items():
                rank[point], above[point] = len(rank), base
        for point in targets:
            if point not in nearest:
                role = f", {roles[point]}," if point in roles else ""
                origin = _first_located_from(point)
                remedy = (
                    f"Use `{point}.set_vel({self.inertial}, ...)` or `{point}.set_pos(...)`."
                    if origin is point
                    else f"If {origin}, from which it is placed, is at rest, use `{origin}.set_vel("
                    f"{self.inertial}, 0)`."
                )
                raise ValueError(
                    f"The point {point}{role} has no velocity in the inertial frame "
                    f"{self.inertial}, and no place from a point that has one. {remedy}"
                )
        located_from = self._hung(targets, nearest)
        paths: dict[Point, BaseAndSteps] = {}
        for point in targets:
            while point is not None and point not in paths:
                if nearest[point] is not None:
                    paths[point] = located_from(point)
                elif above[point] is None or _of_speeds(self.velocity(point)):
                    paths[point] = None, ()
                else:
                    paths[point] = self._structural(point, above, rank, nearest, located_from)
                point = paths[point][0]
        return paths

    def located_beside_speeds(self, bodies: Iterable[Body]) -> dict[Point, BaseAndSteps]:
        """Return where mass centres are whose velocity has speeds as components.

        Each with the nearest point at rest, and the vectors from there, if these turn. The
        equations do not need these positions.
        """
        simple: dict[Point, None] = {}
        for body in bodies:
            velocity = self.velocity(body.masscenter)
            if velocity is not None and _of_speeds(velocity):
                simple[body.masscenter] = None
        resting: dict[Point, None] = {}
        for point in self.points_from([*simple]):
            if self.velocity(point) == 0:
                resting[point] = None
        above = self.points_from([*resting])
        turned: set[Point] = set()  # located from there along axes that turn
        for point, before in above.items():
            if before in turned:
                turned.add(point)
            for _, frame in () if before is None else self.positions(point)[before].args:
                if frame is not self.inertial:
                    turned.add(point)
        located: dict[Point, BaseAndSteps] = {}
        for point in simple:
            if point in turned:
                steps, base = [], point
                while (before := above[base]) is not None:
                    steps.append(self.positions(base)[before])
                    base = before
                located[point] = base, tuple(reversed(steps))
        return located

    def _hung(
        self, targets: Sequence[Point], nearest: dict[Point, Point | None]
    ) -> Callable[[Point], BaseAndSteps]:
        """Return the function that locates a point without a velocity from a point with one.

        It returns the next step to the nearest given velocity. If several are equally near and
        contradict each other, the one that SymPy chooses is used.
        """
        given_paths: dict[Point, BaseAndSteps] = {}
        root: dict[Point, Point] = {}
        for point in targets:
            if nearest[point] is not None and (path := self._nearest_given(point, given_paths)):
                given_paths[point] = path
                root[point] = root.get(given_paths[point][0], given_paths[point][0])
        chosen: dict[Point, BaseAndSteps] = {}
        ends: dict[Point, Point] = {}  # the roots of the paths that agree

        def located_from(point: Point) -> BaseAndSteps:
            before = nearest[point]
            return chosen.get(point) or (before, (FrameTree.positions(point)[before],))

        for point in given_paths:
            chain, end = [], point
            while nearest[end] is not None and end not in ends:
                chain.append(end)
                end = located_from(end)[0]
            end = ends.get(end, end)
            agrees = all(root.get(p, end) is end for p in chain)
            if not agrees and point not in chosen:
                chosen[point] = given_paths[point]
            elif agrees:
                chosen |= {p: located_from(p) for p in chain}
                ends |= dict.fromkeys(chain, end)
        return located_from

    def _nearest_given(self, point: Point, resolved: Container[Point]) -> BaseAndSteps | None:
        """Return the nearest point with a velocity, in SymPy's order, and the path from there.

        As in SymPy's search, positions in frames without orientation are ignored.
        """
        steps: dict[Point, tuple[Vector, ...]] = {point: ()}
        todo = deque([point])
        while todo:
            item = todo.popleft()
            for neighbour, vector in FrameTree.positions(item).items():
                if neighbour in steps or not all(f in self.frame_depth for _, f in vector.args):
                    continue
                steps[neighbour] = (vector, *steps[item])
                if neighbour in resolved or self.velocity(neighbour) is not None:
                    return neighbour, steps[neighbour]
                todo.append(neighbour)
        return None

    @staticmethod
    def _structural(
        point: Point,
        above: dict[Point, Point | None],
        rank: dict[Point, int],
        nearest: dict[Point, Point | None],
        located_from: Callable[[Point], BaseAndSteps],
    ) -> BaseAndSteps:
        """Return the point before one with a given velocity, and the vector between."""
        base, steps = above[point], [FrameTree.positions(point)[above[point]]]
        while True:
            source = base
            while nearest[source] is not None:
                source = located_from(source)[0]
            if rank[source] < rank[point]:
                return base, tuple(steps[::-1])
            steps.append(FrameTree.positions(base)[above[base]])
            base = above[base]


def given_velocity(point: Point, frame: ReferenceFrame) -> Vector | None:
    """Return the velocity that was set, or None; SymPy's `vel` would derive one."""
    return point._vel_dict.get(frame)


def velocity_in(point: Point, frame: ReferenceFrame) -> Vector:
    """Return the velocity of a point, derived from a neighbour if it was not set.

    SymPy's `vel` uses the first neighbour with a velocity, then searches the whole mechanism for a
    warning: along a chain these are n² points.
    """
    if given_velocity(point, frame) is None:
        with_velocity = (
            p for p in FrameTree.positions(point) if given_velocity(p, frame) is not None
        )
        if (neighbour := next(with_velocity, None)) is not None:
            with suppress(ValueError):  # frames are not connected: SymPy uses another neighbour
                rate = FrameTree.positions(point)[neighbour].dt(frame)
                point.set_vel(frame, rate + given_velocity(neighbour, frame))
    return point.vel(frame)


def velocities_in(frame: ReferenceFrame, points: Iterable[Point]) -> dict[Point, Vector]:
    """Return the velocities of points, and leave the points as they are.

    SymPy stores a derived velocity as if the user had set it. A point fixed to the ground would
    become one at rest, from which positions are measured.
    """
    points = [*dict.fromkeys(points)]
    stored = {p: {**p._vel_dict} for p in FrameTree.points_from(points)}
    try:
        return {point: velocity_in(point, frame) for point in points}
    finally:
        for point, velocities in stored.items():
            point._vel_dict.clear()
            point._vel_dict.update(velocities)


def numbers_in_places(frame: ReferenceFrame, bodies: Iterable[Body]) -> set[float]:
    """Return the magnitudes of the numbers in positions of bodies: the lengths with values.

    Other mechanisms may have the same origin: positions along axes that occur on no path to a body
    that moves in the inertial `frame` are theirs.
    """
    bodies = list(bodies)
    centres = [body.masscenter for body in bodies]
    axes = {getattr(body, "frame", None) for body in bodies}
    velocities = [given_velocity(centre, frame) for centre in centres]
    moving = [
        c for c, velocity in zip(centres, velocities, strict=True) if getattr(velocity, "args", 1)
    ]
    vectors = [vector for centre in moving for vector in FrameTree.positions(centre).values()]
    reached = distances(centres[0], FrameTree.positions) if centres else {}
    for point in reached.keys() & centres:  # from the first of them
        vectors += steps_to(point, reached)
    axes |= {axis for vector in vectors for _, axis in vector.args}
    waiting, visited, numbers = [*centres], {*centres}, set()
    while waiting:
        for neighbour, vector in FrameTree.positions(waiting.pop()).items():
            if not {axis for _, axis in vector.args} <= axes:
                continue
            every = (e for part, _ in vector.args for e in part)
            for term in (term for e in every for term in sm.Add.make_args(e)):
                if not isinstance(term.as_coeff_Mul()[1], AppliedUndef):  # coordinates have factors
                    numbers |= {abs(float(number)) for number in term.atoms(sm.Number)}
            if neighbour not in visited:
                visited.add(neighbour)
                waiting.append(neighbour)
    return {size for size in numbers if size > 0.0}


def breadth_first(
    roots: Sequence[Item], neighbours: Callable[[Item], Iterable[Item]]
) -> dict[Item, Item | None]:
    """Return roots and all items connected with them, nearest first, with their parents."""
    parent, todo = dict.fromkeys(roots), deque(roots)
    while todo:
        item = todo.popleft()
        for neighbour in neighbours(item):
            if neighbour not in parent:
                parent[neighbour] = item
                todo.append(neighbour)
    return parent


def distances(root: Item, neighbours: Callable[[Item], Iterable[Item]]) -> dict[Item, int]:
    """Return all items connected with a root, and the number of steps to each."""
    steps: dict[Item, int] = {}
    for item, before in breadth_first([root], neighbours).items():
        steps[item] = 0 if before is None else steps[before] + 1
    return steps


def steps_to(point: Point, away: Mapping[Point, int]) -> list[Vector]:
    """Return the vectors on the path to a point from the root of `away`, the last first."""
    steps = []
    for _ in range(away[point]):
        before = _nearer(point, FrameTree.positions(point), away)
        steps.append(FrameTree.positions(point)[before])
        point = before
    return steps


def _nearer(item: Item, neighbours: Iterable[Item], away: Mapping[Item, int]) -> Item | None:
    """Return the first neighbour nearer to the root, as SymPy does; None for the root."""
    return next((n for n in neighbours if away[n] < away[item]), None)


def _first_located_from(point: Point) -> Point:
    """Return the first point of a chain of positions, in order of definition."""
    chain = [point]
    while (before := next(iter(FrameTree.positions(chain[-1])), None)) not in (None, *chain):
        chain.append(before)
    return chain[-1]


def _of_speeds(vector: Vector) -> bool:
    """Return whether the components in one frame are single functions of time, or zero."""
    return len(vector.args) == 1 and all(
        part == 0 or isinstance(part, AppliedUndef) for part in vector.args[0][0]
    )


def _length(vector: Vector) -> float:
    """Return the written length of a velocity; vectors in several frames count as longest."""
    if len(vector.args) > 1:
        return float("inf")
    return float(sum(sm.count_ops(part) + 1 for parts, _ in vector.args for part in parts))
