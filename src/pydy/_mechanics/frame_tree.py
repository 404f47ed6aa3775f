"""Frames and points of SymPy: where they are relative to one another, as the user gave it.

The only module that reads the private attributes of SymPy's vector classes.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from contextlib import suppress
from typing import Any

import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._forks import cached_property

# The point from which a point is reached, None for a root, and the vectors on the way.
Way = tuple[Any, tuple[Any, ...]]


class FrameTree:
    """Frames and points as the user related them to one another, seen from an inertial frame."""

    def __init__(self, inertial: Any) -> None:
        self.inertial = inertial

    # -- frames -----------------------------------------------------------------------------------

    @staticmethod
    def orientations(frame: Any) -> dict[Any, Any]:
        """Return the frames that a frame is oriented in or relative to it, with the matrices."""
        found: dict[Any, Any] = frame._dcm_dict
        return found

    @cached_property
    def frame_depth(self) -> dict[Any, int]:
        """The frames with an orientation, by their number of rotations from the inertial frame."""
        return distances(self.inertial, self.orientations)

    def rotation_matrices(self) -> list[Any]:
        """Return the matrices of all orientations, from the inertial frame outwards."""
        depth = self.frame_depth
        pairs = [
            (matrix, depth[other] > depth[frame])
            for frame in depth
            for other, matrix in self.orientations(frame).items()
        ]
        return [m.as_immutable() for m, outwards in pairs if outwards]  # one may be the user's own

    @cached_property
    def spin_depth(self) -> dict[Any, int]:
        """The frames with an angular velocity, by their number of steps from the inertial frame."""
        return distances(self.inertial, lambda f: f._ang_vel_dict)

    def parent(self, frame: Any) -> Any:
        """Return the next frame on the way to the inertial one, None for that itself."""
        if frame not in self.frame_depth:
            raise ValueError(
                f"The frame {frame} has no orientation in the inertial frame {self.inertial}. "
                f"Orient it, or one of the frames that it is oriented in: `{frame}.orient_axis("
                f"{self.inertial}, ...)`."
            )
        return _nearer(frame, frame._dcm_dict, self.frame_depth)

    def turns_in(self, frame: Any) -> Any:
        """Return the frame in which a frame's angular velocity is given, None for the inertial."""
        if frame not in self.spin_depth:
            self.parent(frame)  # says more where it is not even oriented
            raise ValueError(
                f"The frame {frame} has no angular velocity in the inertial frame "
                f"{self.inertial}. Give it one: `{frame}.set_ang_vel({self.inertial}, ...)`."
            )
        return _nearer(frame, frame._ang_vel_dict, self.spin_depth)

    @staticmethod
    def rotation(frame: Any, parent: Any) -> Any:
        """Return the matrix from components in the parent to those in a frame."""
        return frame._dcm_dict[parent]

    @staticmethod
    def relative_spin(frame: Any, base: Any) -> Any:
        """Return the angular velocity that was given between two frames."""
        return frame._ang_vel_dict[base]

    def angular_acceleration(self, frame: Any) -> Any:
        """Return the angular acceleration that the user set in the inertial frame, or None."""
        return frame._ang_acc_dict.get(self.inertial)

    # -- points -----------------------------------------------------------------------------------

    @staticmethod
    def positions(point: Any) -> dict[Any, Any]:
        """Return the points that are located relative to a point, with the vectors from there."""
        found: dict[Any, Any] = point._pos_dict
        return found

    @staticmethod
    def points_from(points: Sequence[Any]) -> dict[Any, Any]:
        """Return points and all that are located from them, nearest first, with the point before.

        That is None for the points themselves.
        """
        return breadth_first(points, FrameTree.positions)

    def velocity(self, point: Any) -> Any:
        """Return the velocity that the user set, or None."""
        return given_velocity(point, self.inertial)

    def acceleration(self, point: Any) -> Any:
        """Return the acceleration that the user set, or None."""
        return point._acc_dict.get(self.inertial)

    def paths(self, points: Iterable[Any], roles: Mapping[Any, str]) -> dict[Any, Way]:
        """Return for each point another one and the vectors from there, (None, ()) for roots.

        The vectors lead to a point whose motion is known without this one's: a given velocity can
        then be compared with that of the place. None is shorter than one whose components are
        speeds: that is a root. A point without one hangs on the nearest that has one, as in SymPy.
        """
        wanted = list(dict.fromkeys(points))
        seen = list(self.points_from(wanted))
        given = [p for p in seen if self.velocity(p) is not None]
        simple = sorted(given, key=lambda p: len(self.velocity(p).args) > 0)
        if simple and self.velocity(simple[0]).args:
            simple = sorted(given, key=lambda p: _length(self.velocity(p)))
        nearest = self.points_from(given)
        rank: dict[Any, int] = {}
        above: dict[Any, Any] = {}
        for root in simple:
            if root in rank:
                continue
            for point, base in self.points_from([root]).items():
                rank[point], above[point] = len(rank), base
        for point in wanted:
            if point not in nearest:
                role = f", {roles[point]}," if point in roles else ""
                rest = _beginning(point)
                remedy = (
                    f"Use `{point}.set_vel({self.inertial}, ...)` or `{point}.set_pos(...)`."
                    if rest is point
                    else f"If {rest}, from which it is placed, is at rest, use `{rest}.set_vel("
                    f"{self.inertial}, 0)`."
                )
                raise ValueError(
                    f"The point {point}{role} has no velocity in the inertial frame "
                    f"{self.inertial}, and no place from a point that has one. {remedy}"
                )
        hung = self._hung(wanted, nearest)
        found: dict[Any, Way] = {}
        for point in wanted:
            while point is not None and point not in found:
                if nearest[point] is not None:
                    found[point] = hung(point)
                elif above[point] is None or _of_speeds(self.velocity(point)):
                    found[point] = None, ()
                else:
                    found[point] = self._structural(point, above, rank, nearest, hung)
                point = found[point][0]
        return found

    def _hung(self, wanted: Sequence[Any], nearest: dict[Any, Any]) -> Callable[[Any], Way]:
        """Return the step that locates a point without a velocity from a point with one.

        That is the next on the way to a nearest given velocity. Where several are equally near and
        contradict each other it matters which: it is the one that SymPy takes.
        """
        own: dict[Any, Way] = {}
        root: dict[Any, Any] = {}
        for point in wanted:
            if nearest[point] is not None and (way := self._nearest_given(point, own)):
                own[point] = way
                root[point] = root.get(own[point][0], own[point][0])
        ways: dict[Any, Way] = {}
        ends: dict[Any, Any] = {}  # where the ways that agree lead to

        def hung(point: Any) -> Way:
            before = nearest[point]
            return ways.get(point) or (before, (FrameTree.positions(point)[before],))

        for point in own:
            chain, end = [], point
            while nearest[end] is not None and end not in ends:
                chain.append(end)
                end = hung(end)[0]
            end = ends.get(end, end)
            agrees = all(root.get(p, end) is end for p in chain)
            if not agrees and point not in ways:
                ways[point] = own[point]
            elif agrees:
                ways |= {p: hung(p) for p in chain}
                ends |= dict.fromkeys(chain, end)
        return hung

    def _nearest_given(self, point: Any, resolved: Container[Any]) -> Way | None:
        """Return the nearest point with a velocity, in SymPy's order, and the way from there.

        Like SymPy's search this one leaves out places in frames without orientation.
        """
        steps: dict[Any, tuple[Any, ...]] = {point: ()}
        todo = deque([point])
        while todo:
            item = todo.popleft()
            for other, vector in FrameTree.positions(item).items():
                if other in steps or not all(f in self.frame_depth for _, f in vector.args):
                    continue
                steps[other] = (vector, *steps[item])
                if other in resolved or self.velocity(other) is not None:
                    return other, steps[other]
                todo.append(other)
        return None

    @staticmethod
    def _structural(
        point: Any,
        above: dict[Any, Any],
        rank: dict[Any, int],
        nearest: dict[Any, Any],
        hung: Callable[[Any], Way],
    ) -> Way:
        """Return the point before one with a given velocity, and the vector between."""
        base, steps = above[point], [FrameTree.positions(point)[above[point]]]
        while True:
            source = base
            while nearest[source] is not None:
                source = hung(source)[0]
            if rank[source] < rank[point]:
                return base, tuple(steps[::-1])
            steps.append(FrameTree.positions(base)[above[base]])
            base = above[base]


def given_velocity(point: Any, frame: Any) -> Any:
    """Return the velocity that was set, or None; SymPy's `vel` would make one up."""
    return point._vel_dict.get(frame)


def velocity_in(point: Any, frame: Any) -> Any:
    """Return the velocity of a point, made up from a neighbour's where nobody set it.

    SymPy's `vel` takes that of the first neighbour that has one, then looks at all others of the
    mechanism, for a warning: along a chain that is n² points.
    """
    if given_velocity(point, frame) is None:
        known = (p for p in FrameTree.positions(point) if given_velocity(p, frame) is not None)
        if (neighbour := next(known, None)) is not None:
            with suppress(ValueError):  # of frames that nobody connected: SymPy takes another
                rate = FrameTree.positions(point)[neighbour].dt(frame)
                point.set_vel(frame, rate + given_velocity(neighbour, frame))
    return point.vel(frame)


def numbers_in_places(frame: Any, bodies: Iterable[Any]) -> set[float]:
    """Return the sizes of the numbers by which bodies are placed: the lengths that have values.

    Other mechanisms may hang on the same origin: what is placed along axes by which no body that
    moves in the inertial `frame` is reached is theirs.
    """
    bodies = list(bodies)
    centres = [body.masscenter for body in bodies]
    axes = {getattr(body, "frame", None) for body in bodies}
    given = [given_velocity(centre, frame) for centre in centres]
    moving = [c for c, velocity in zip(centres, given, strict=True) if getattr(velocity, "args", 1)]
    ways = [way for centre in moving for way in FrameTree.positions(centre).values()]
    reached = distances(centres[0], FrameTree.positions) if centres else {}
    for point in reached.keys() & centres:  # from the first of them
        ways += steps_to(point, reached)
    axes |= {along for way in ways for _, along in way.args}
    waiting, seen, found = [*centres], {*centres}, set()
    while waiting:
        for other, way in FrameTree.positions(waiting.pop()).items():
            if not {along for _, along in way.args} <= axes:
                continue
            every = (e for part, _ in way.args for e in part)
            for term in (term for e in every for term in sm.Add.make_args(e)):
                if not isinstance(term.as_coeff_Mul()[1], AppliedUndef):  # coordinates have factors
                    found |= {abs(float(number)) for number in term.atoms(sm.Number)}
            if other not in seen:
                seen.add(other)
                waiting.append(other)
    return {size for size in found if size > 0.0}


def breadth_first(
    roots: Sequence[Any], neighbours: Callable[[Any], Iterable[Any]]
) -> dict[Any, Any]:
    """Return roots and all that can be reached from them, the nearest first, with their parents."""
    parent, todo = dict.fromkeys(roots), deque(roots)
    while todo:
        item = todo.popleft()
        for other in neighbours(item):
            if other not in parent:
                parent[other] = item
                todo.append(other)
    return parent


def distances(root: Any, neighbours: Callable[[Any], Iterable[Any]]) -> dict[Any, int]:
    """Return all that can be reached from a root, and in how many steps."""
    found: dict[Any, int] = {}
    for item, before in breadth_first([root], neighbours).items():
        found[item] = 0 if before is None else found[before] + 1
    return found


def steps_to(point: Any, away: Mapping[Any, int]) -> list[Any]:
    """Return the vectors on the way to a point from where `away` counts from, the last first."""
    steps = []
    for _ in range(away[point]):
        before = _nearer(point, FrameTree.positions(point), away)
        steps.append(FrameTree.positions(point)[before])
        point = before
    return steps


def _nearer(item: Any, neighbours: Iterable[Any], away: Mapping[Any, int]) -> Any:
    """Return the first neighbour nearer to the root, as SymPy does, None for the root itself."""
    return next((n for n in neighbours if away[n] < away[item]), None)


def _beginning(point: Any) -> Any:
    """Return the point from which a chain of places began, as far as their order tells."""
    seen = [point]
    while (before := next(iter(FrameTree.positions(seen[-1])), None)) not in (None, *seen):
        seen.append(before)
    return seen[-1]


def _of_speeds(vector: Any) -> bool:
    """Return whether the components in one frame are single functions of time, or zero."""
    return len(vector.args) == 1 and all(
        part == 0 or isinstance(part, AppliedUndef) for part in vector.args[0][0]
    )


def _length(vector: Any) -> float:
    """Return the written length of a velocity; vectors in several frames count as longest."""
    if len(vector.args) > 1:
        return float("inf")
    return float(sum(sm.count_ops(part) + 1 for parts, _ in vector.args for part in parts))
