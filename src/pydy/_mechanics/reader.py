"""What SymPy's frames, points, bodies and loads hold, as the user gave it.

The only module that reads the private attributes of SymPy's vector classes.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import (
    ForceActuator,
    LinearDamper,
    LinearPathway,
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    Vector,
    WrappingCylinder,
    WrappingPathway,
)

from pydy._checks import shown, typed
from pydy._errors import warn_user
from pydy._forks import cached_property
from pydy._graph import Graph, SymPyReader
from pydy._mechanics.components import numbers_of
from pydy._mechanics.symbols import rate_of
from pydy._rank import ROUNDED

# The point from which a point is reached, None for a root, and the vectors on the way.
Way = tuple[Any, tuple[Any, ...]]


@dataclass(frozen=True, eq=False)
class Multibody:
    """Bodies, loads and kinematics, from which equations of motion are formed."""

    frame: Any  # the inertial frame
    bodies: tuple[Any, ...]
    loads: tuple[tuple[Any, Any], ...]
    time: Any
    coordinates: tuple[Any, ...]  # in the order of the states, like the speeds
    speeds: tuple[Any, ...]
    coordinate_rates: tuple[Any, ...]
    coordinate_derivatives: tuple[Any, ...]  # q' in q, u and t
    holonomic: tuple[Any, ...] = ()  # configuration constraints, zero when satisfied
    velocity: tuple[Any, ...] = ()  # velocity constraints, one for each dependent speed
    # Their derivatives, in u' and the states; empty where they are just that.
    acceleration: tuple[Any, ...] = ()
    auxiliary: tuple[Any, ...] = ()  # auxiliary speeds
    # Of the coordinates and speeds; the speeds in the order of the velocity constraints.
    dependent_coordinates: tuple[Any, ...] = ()
    dependent_speeds: tuple[Any, ...] = ()
    chosen: tuple[Any, ...] = ()  # those of the dependent ones that the user did not name
    # In place of bodies; the speeds are then the derivatives of the coordinates.
    lagrangian: Any = None
    # More velocity constraints, which follow from the others at generic states.
    redundant: tuple[Any, ...] = ()
    # More holonomic constraints, which follow from the others wherever their speeds do.
    closed: tuple[Any, ...] = ()
    # Whether no choice of dependent speeds is to be relied on: the rank of the constraints,
    # or what they can be solved for, may change as the system moves.
    changing: bool = False
    implicit: Any = None  # the `Implicit` that gave some coordinates and holonomic constraints
    activations: tuple[Any, ...] = ()  # states of musculotendons that are specifieds here
    # The bodies as they were when they were first read, which SymPy lets change afterwards.
    noted: tuple[tuple[Any, tuple[Any, ...]], ...] = ()

    def __post_init__(self) -> None:
        if not self.noted:
            noted = tuple((body, _noted(body)) for body in self.bodies)
            object.__setattr__(self, "noted", noted)

    @property
    def places(self) -> list[Any]:
        """The holonomic constraints, except the residuals of an `Implicit`."""
        given = set() if self.implicit is None else {*self.implicit.residuals.values()}
        return [e for e in (*self.holonomic, *self.closed) if e not in given]

    def check_unchanged(self) -> None:
        """Refuse bodies that changed since they were read: later derivations would contradict."""
        for body, before in self.noted:
            names = ("mass", "inertia", "mass center", "frame", "position", "orientation")
            for name, old, new in zip(names, before, _noted(body), strict=True):
                if isinstance(old, dict):  # SymPy adds neighbours as it goes
                    new = {key: new.get(key) for key in old}
                if old is not new and old != new:
                    said = "" if isinstance(old, dict) else f" from {old} to {new}"
                    raise ValueError(
                        f"The {name} of the body `{body.name}` has been changed{said} since the "
                        "System was made. Its equations of motion are those from before: make a "
                        "new System, or undo the change. For values that vary, use constants."
                    )

    @cached_property
    def speed_rates(self) -> tuple[Any, ...]:
        """The derivatives of the speeds."""
        return tuple(rate_of(u, self.time) for u in self.speeds)

    @cached_property
    def dependent_columns(self) -> tuple[int, ...]:
        """The positions of the dependent speeds among the speeds, in their own order."""
        return tuple(self.speeds.index(u) for u in self.dependent_speeds)

    @property
    def independent_first(self) -> Multibody:
        """The same with the dependent coordinates and speeds last, as equations are formed."""
        coordinates = _last(self.coordinates, self.dependent_coordinates)
        speeds = _last(self.speeds, self.dependent_speeds)
        if (coordinates, speeds) == (self.coordinates, self.speeds):
            return self
        order = [self.coordinates.index(q) for q in coordinates]
        return replace(
            self,
            coordinates=coordinates,
            speeds=speeds,
            coordinate_rates=tuple(self.coordinate_rates[k] for k in order),
            coordinate_derivatives=tuple(self.coordinate_derivatives[k] for k in order),
        )


def _last(symbols: Sequence[Any], dependent: Sequence[Any]) -> tuple[Any, ...]:
    """Return the symbols with the dependent ones last."""
    return (*(s for s in symbols if s not in dependent), *dependent)


def _noted(body: Any) -> tuple[Any, ...]:
    """Return a record of a body's properties for `Multibody.check_unchanged`."""
    point = body.masscenter
    if not is_rigid(body):
        return body.mass, None, point, None, {**places(point)}, {}
    inertia = body.inertia
    return body.mass, inertia, point, body.frame, {**places(point)}, {**oriented(body.frame)}


def read_loads(loads: Iterable[Any]) -> tuple[tuple[Any, Any], ...]:
    """Return loads as pairs of a point and a force, or a frame and a torque."""
    found: list[tuple[Any, Any]] = []
    for load in loads:
        if hasattr(load, "to_loads"):
            found += [(where, vector) for where, vector in read_loads(_loads_of(load))]
            continue
        if not isinstance(load, tuple) or len(load) != 2:
            raise TypeError(
                f"The load {shown(load)} is not one of the loads that System knows: give a pair of "
                "a "
                "Point and a force Vector, a pair of a ReferenceFrame and a torque Vector, a "
                "Force, a Torque, or an actuator with `to_loads()`."
            )
        where, vector = load
        if not isinstance(where, (Point, ReferenceFrame)):
            raise ValueError(
                f"The load ({where}, {vector}) must begin with the Point that the force acts at, "
                f"or the ReferenceFrame that the torque acts on, got a {type(where).__name__}."
            )
        if vector != 0:
            checked_vector(vector, f"The load at {where}")
            # What an actuator made is a Force, which `pydy._mechanics.wrapping` looks at.
            found.append(load)
    return tuple(found)


def checked_vector(value: Any, what: str) -> Any:
    """Return a Vector, or raise an error that shows the value."""
    if not isinstance(value, Vector):
        raise TypeError(
            f"{what} must be a Vector, such as {shown(value)}*N.x with the axis of a frame N, got "
            f"{typed(value)}."
        )
    if not all(isinstance(part, sm.MatrixBase) for part, _ in value.args):
        # SymPy makes this of a vector that is multiplied by NaN, and cannot print it.
        raise ValueError(f"{what} is NaN times a vector. Give it one that is defined.")
    return value


def _loads_of(actuator: Any) -> Any:
    """Return the loads of an actuator.

    SymPy differentiates a damper's length, the root of all terms of its square. The length times
    its rate is the way between the points times that way's own rate, which is a velocity.
    """
    if is_reversed(actuator):
        warn_of_reversed(f"A {type(actuator).__name__}")
    if type(actuator) is not LinearDamper or type(actuator.pathway) is not LinearPathway:
        return actuator.to_loads()
    start, end = actuator.pathway.attachments
    way = end.pos_from(start)
    if way == 0:
        return actuator.to_loads()
    force = actuator.damping * way.dt(way.args[0][1]).dot(way) / way.dot(way) * way
    return [(start, force), (end, -force)]


def is_reversed(actuator: Any) -> bool:
    """Return whether an actuator pushes where it should pull; a ForceActuator's sign is chosen."""
    path = getattr(actuator, "pathway", None)
    if type(actuator) is ForceActuator or not isinstance(path, WrappingPathway):
        return False
    return wrapped_force_pulls()


def warn_of_reversed(what: str) -> None:
    """Warn of a force along a WrappingPathway that has the wrong sign."""
    warn_user(
        f"{what} along a WrappingPathway pushes where it should pull, and pulls where it should "
        "push: SymPy applies a positive force inwards there, and outwards along other pathways. "
        "Pass `ForceActuator(-actuator.force, actuator.pathway)`, a force whose sign you choose, "
        "in its place."
    )


def activation_states(loads: Iterable[Any], coordinates: Container[Any]) -> list[Any]:
    """Return states of musculotendons, activations and fibre lengths, that are no coordinates."""
    every = (s for muscle in _with_states(loads) for s in muscle.x)
    return [s for s in dict.fromkeys(every) if s not in coordinates]


def activation_dynamics(loads: Iterable[Any]) -> dict[Any, Any]:
    """Return the derivatives of the states of musculotendons."""
    found: dict[Any, Any] = {}
    for muscle in _with_states(loads):
        found.update(zip(muscle.x, muscle.rhs(), strict=True))
    return found


def _with_states(loads: Iterable[Any]) -> list[Any]:
    """Return the musculotendons among loads, which have states `x` and derivatives `rhs()`."""
    return [
        load
        for load in loads
        if isinstance(getattr(load, "x", None), sm.MatrixBase) and hasattr(load, "rhs")
    ]


@cache
def wrapped_force_pulls() -> bool:
    """Return whether a positive force along a quarter of a cylinder pulls at its ends.

    Springs, dampers and muscles mean one that pushes; that SymPy's geometry does not may be mended.
    """
    frame, centre = ReferenceFrame("N"), Point("O")
    start, end = centre.locatenew("P", frame.x), centre.locatenew("Q", frame.y)
    path = WrappingPathway(start, end, WrappingCylinder(1, centre, frame.z))
    return bool(path.to_loads(sm.Integer(1))[0].force.dot(frame.y) > 0)


def is_rigid(body: Any) -> bool:
    """Return whether a body has a frame and an inertia."""
    return isinstance(body, RigidBody)


def check_bodies(bodies: Iterable[Any]) -> tuple[Any, ...]:
    """Return bodies as a tuple."""
    found, seen = tuple(bodies), set()
    for body in found:
        if id(body) in seen:
            raise ValueError(
                f"`bodies` has {getattr(body, 'name', body)} more than once: its mass would count "
                "as often. Name it once."
            )
        seen.add(id(body))
        if not isinstance(body, (RigidBody, Particle)):
            raise TypeError(
                f"`bodies` must hold Particle and RigidBody objects, got {shown(body)} of type "
                f"{type(body).__name__}."
            )
        if is_rigid(body):
            _check_symmetric(body)
    return found


def _check_symmetric(body: Any) -> None:
    """Refuse an inertia dyadic in one frame of which a product is there only once."""
    terms = body.central_inertia.args
    # A dyadic holds its frame's own unit vectors: to compare them takes longer.
    axes = {id(axis) for axis in terms[0][1].args[0][1]} if terms else set()
    if any(id(v) not in axes for _, *both in terms for v in both):
        return
    cells = {(id(a), id(b)): size for size, a, b in terms}
    unlike = [
        (size, other, a, b)
        for size, a, b in terms
        if size != (other := cells.get((id(b), id(a)), sm.S.Zero))
    ]
    if not unlike:
        return
    graph = Graph()
    read = InputReader(graph, {}, ()).all
    values = numbers_of(graph, read([*(e for row in unlike for e in row[:2]), *cells.values()]))
    allowed = ROUNDED * abs(values).max(axis=1)
    for k, (size, other, a, b) in enumerate(unlike):
        if (abs(values[:, 2 * k] - values[:, 2 * k + 1]) > allowed).any():
            raise ValueError(
                f"The inertia of the body {body.name} is not symmetric: it has {size} at "
                f"({a}|{b}), and {other} at ({b}|{a}). Give both, as `inertia(frame, ixx, iyy, "
                "izz, ixy, iyz, izx)` does."
            )


class InputReader(SymPyReader):
    """Reads expressions; symbols other than states and time become inputs when they occur."""

    def __init__(self, graph: Graph, atoms: dict[Any, int], states: Sequence[Any]) -> None:
        super().__init__(graph, atoms, "the bodies, loads and kinematics")
        self.states = frozenset(states)
        self.constants: list[Any] = []
        self.specifieds: list[Any] = []
        self.second: Callable[[Any], int | None] = lambda symbol: None

    def _leaf(self, expr: Any) -> int | None:
        if expr not in self.atoms:
            if isinstance(expr, sm.Symbol):
                self.atoms[expr] = self.graph.input("p", len(self.constants))
                self.constants.append(expr)
            elif isinstance(expr, (AppliedUndef, sm.Derivative)):
                return self._function(expr)
        return super()._leaf(expr)

    def _function(self, expr: Any) -> int:
        if isinstance(expr, sm.Derivative) and expr.expr in self.states:
            node = self.second(expr)
            if node is None:
                raise ValueError(
                    f"{self.what} hold `{expr}`, but of the coordinates and speeds only the first "
                    "derivatives are available. Rewrite it in terms of the speeds and their first "
                    "derivatives."
                )
            self.atoms[expr] = node
            return node
        self.atoms[expr] = node = self.graph.input("r", len(self.specifieds))
        self.specifieds.append(expr)
        return node


def places(point: Any) -> dict[Any, Any]:
    """Return the points whose place is known from a point, each with the vector from there."""
    found: dict[Any, Any] = point._pos_dict
    return found


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
    ways = [way for centre in moving for way in places(centre).values()]
    reached = distances(centres[0], places) if centres else {}
    for point in reached.keys() & centres:  # from the first of them
        ways += steps_to(point, reached)
    axes |= {along for way in ways for _, along in way.args}
    waiting, seen, found = [*centres], {*centres}, set()
    while waiting:
        for other, way in places(waiting.pop()).items():
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


def given_velocity(point: Any, frame: Any) -> Any:
    """Return the velocity that was set, or None; SymPy's `vel` would make one up."""
    return point._vel_dict.get(frame)


def velocity_in(point: Any, frame: Any) -> Any:
    """Return the velocity of a point, made up from a neighbour's where nobody set it.

    SymPy's `vel` takes that of the first neighbour that has one, then looks at all others of the
    mechanism, for a warning: along a chain that is n² points.
    """
    if given_velocity(point, frame) is None:
        known = (p for p in places(point) if given_velocity(p, frame) is not None)
        if (neighbour := next(known, None)) is not None:
            with suppress(ValueError):  # of frames that nobody connected: SymPy takes another
                rate = places(point)[neighbour].dt(frame)
                point.set_vel(frame, rate + given_velocity(neighbour, frame))
    return point.vel(frame)


def oriented(frame: Any) -> dict[Any, Any]:
    """Return the frames that a frame is oriented in, or that are in it, each with the matrix."""
    found: dict[Any, Any] = frame._dcm_dict
    return found


class Tree:
    """How frames and points hang together, from an inertial frame outwards."""

    def __init__(self, inertial: Any) -> None:
        self.inertial = inertial
        self.oriented = distances(inertial, oriented)
        self.turning = distances(inertial, lambda f: f._ang_vel_dict)

    # -- frames -----------------------------------------------------------------------------------

    def parent(self, frame: Any) -> Any:
        """Return the next frame on the way to the inertial one, None for that itself."""
        if frame not in self.oriented:
            raise ValueError(
                f"The frame {frame} has no orientation in the inertial frame {self.inertial}. "
                f"Orient it, or one of the frames that it is oriented in: `{frame}.orient_axis("
                f"{self.inertial}, ...)`."
            )
        return _nearer(frame, frame._dcm_dict, self.oriented)

    def turns_in(self, frame: Any) -> Any:
        """Return the frame in which a frame's angular velocity is given, None for the inertial."""
        if frame not in self.turning:
            self.parent(frame)  # says more where it is not even oriented
            raise ValueError(
                f"The frame {frame} has no angular velocity in the inertial frame "
                f"{self.inertial}. Give it one: `{frame}.set_ang_vel({self.inertial}, ...)`."
            )
        return _nearer(frame, frame._ang_vel_dict, self.turning)

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
        seen = list(breadth_first_from(wanted))
        given = [p for p in seen if self.velocity(p) is not None]
        simple = sorted(given, key=lambda p: len(self.velocity(p).args) > 0)
        if simple and self.velocity(simple[0]).args:
            simple = sorted(given, key=lambda p: _length(self.velocity(p)))
        nearest = breadth_first_from(given)
        rank: dict[Any, int] = {}
        above: dict[Any, Any] = {}
        for root in simple:
            if root in rank:
                continue
            for point, base in breadth_first_from([root]).items():
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
            return ways.get(point) or (nearest[point], (places(point)[nearest[point]],))

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
            for other, vector in places(item).items():
                if other in steps or not all(f in self.oriented for _, f in vector.args):
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
        base, steps = above[point], [places(point)[above[point]]]
        while True:
            source = base
            while nearest[source] is not None:
                source = hung(source)[0]
            if rank[source] < rank[point]:
                return base, tuple(steps[::-1])
            steps.append(places(base)[above[base]])
            base = above[base]


def distances(root: Any, neighbours: Callable[[Any], Iterable[Any]]) -> dict[Any, int]:
    """Return all that can be reached from a root, and in how many steps."""
    found: dict[Any, int] = {}
    for item, before in breadth_first_from([root], neighbours).items():
        found[item] = 0 if before is None else found[before] + 1
    return found


def steps_to(point: Any, away: Mapping[Any, int]) -> list[Any]:
    """Return the vectors on the way to a point from where `away` counts from, the last first."""
    steps = []
    for _ in range(away[point]):
        before = _nearer(point, places(point), away)
        steps.append(places(point)[before])
        point = before
    return steps


def _nearer(item: Any, neighbours: Iterable[Any], away: Mapping[Any, int]) -> Any:
    """Return the first neighbour nearer to the root, as SymPy does, None for the root itself."""
    return next((n for n in neighbours if away[n] < away[item]), None)


def breadth_first_from(
    roots: Sequence[Any], neighbours: Callable[[Any], Iterable[Any]] = places
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


def _beginning(point: Any) -> Any:
    """Return the point from which a chain of places began, as far as their order tells."""
    seen = [point]
    while (before := next(iter(places(seen[-1])), None)) not in (None, *seen):
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
