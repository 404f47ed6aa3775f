"""Loads, actuators, bodies and expressions, as the user gave them."""

from __future__ import annotations

import sys
from collections.abc import Callable, Container, Iterable, Sequence
from functools import cache
from typing import TYPE_CHECKING

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
from pydy._graph import Graph, SymPyReader
from pydy._mechanics.components import numbers_of
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    from sympy.physics.biomechanics import MusculotendonBase
    from sympy.physics.mechanics import ActuatorBase

    from pydy._sympy_types import AnySymbol, Body, Load, TimeFunction


def read_loads(loads: Iterable[Load | ActuatorBase]) -> tuple[Load, ...]:
    """Return loads as pairs of a point and a force, or a frame and a torque."""
    pairs: list[Load] = []
    for load in loads:
        if hasattr(load, "to_loads"):
            pairs += [(location, vector) for location, vector in read_loads(_loads_of(load))]
            continue
        if not isinstance(load, tuple) or len(load) != 2:
            raise TypeError(
                f"The load {shown(load)} is not one of the loads that System knows: give a pair of "
                "a "
                "Point and a force Vector, a pair of a ReferenceFrame and a torque Vector, a "
                "Force, a Torque, or an actuator with `to_loads()`."
            )
        location, vector = load
        if not isinstance(location, (Point, ReferenceFrame)):
            raise ValueError(
                f"The load ({location}, {vector}) must begin with the Point that the force acts "
                "at, or the ReferenceFrame that the torque acts on, got a "
                f"{type(location).__name__}."
            )
        if vector != 0:
            checked_vector(vector, f"The load at {location}")
            # Loads of actuators are Forces, which `pydy._mechanics.wrapping` examines.
            pairs.append(load)
    return tuple(pairs)


def checked_vector(value: object, what: str) -> Vector:
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


def _loads_of(actuator: ActuatorBase) -> Iterable[Load]:
    """Return the loads of an actuator.

    SymPy differentiates a damper's length, a root of many terms. The length times its rate is the
    vector between the points times the rate of that vector, which is a velocity.
    """
    if is_reversed(actuator):
        warn_of_reversed(f"A {type(actuator).__name__}")
    if type(actuator) is not LinearDamper or type(actuator.pathway) is not LinearPathway:
        loads: Iterable[Load] = actuator.to_loads()
        return loads
    start, end = actuator.pathway.attachments
    vector = end.pos_from(start)
    if vector == 0:
        loads = actuator.to_loads()
        return loads
    force = (
        actuator.damping * vector.dt(vector.args[0][1]).dot(vector) / vector.dot(vector) * vector
    )
    return [(start, force), (end, -force)]


def is_reversed(actuator: ActuatorBase) -> bool:
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


def activation_states(
    loads: Iterable[Load | ActuatorBase], coordinates: Container[TimeFunction]
) -> list[TimeFunction]:
    """Return states of musculotendons, activations and fibre lengths, that are no coordinates."""
    every = (s for muscle in _with_states(loads) for s in muscle.x)
    return [s for s in dict.fromkeys(every) if s not in coordinates]


def activation_dynamics(loads: Iterable[Load | ActuatorBase]) -> dict[TimeFunction, sm.Expr]:
    """Return the derivatives of the states of musculotendons."""
    derivatives: dict[TimeFunction, sm.Expr] = {}
    for muscle in _with_states(loads):
        derivatives.update(zip(muscle.x, muscle.rhs(), strict=True))
    return derivatives


def _with_states(loads: Iterable[Load | ActuatorBase]) -> list[MusculotendonBase]:
    """Return the musculotendons among loads, which have states `x` and derivatives `rhs()`."""
    return [
        load
        for load in loads
        if isinstance(getattr(load, "x", None), sm.MatrixBase) and hasattr(load, "rhs")
    ]


def curve_coefficients(loads: Iterable[Load]) -> tuple[sm.Symbol, ...]:
    """Return the symbols for coefficients of characteristic curves of muscles, in order.

    SymPy makes them where a musculotendon has none of its own; its argument is what comes first.
    """
    curves = sys.modules.get("sympy.physics.biomechanics.curve")
    if curves is None:  # nobody has made one; what the loads hold need not be read
        return ()
    parts = (part for _, vector in loads for matrix, _ in vector.args for part in matrix)
    functions = {f for part in parts for f in part.atoms(curves.CharacteristicCurveFunction)}
    symbols = {s for f in functions for argument in f.args[1:] for s in argument.free_symbols}
    return tuple(sm.ordered(symbols))


@cache
def wrapped_force_pulls() -> bool:
    """Return whether a positive force along a quarter of a cylinder pulls at its ends.

    Springs, dampers and muscles expect one that pushes; a later SymPy may correct its geometry.
    """
    frame, centre = ReferenceFrame("N"), Point("O")
    start, end = centre.locatenew("P", frame.x), centre.locatenew("Q", frame.y)
    path = WrappingPathway(start, end, WrappingCylinder(1, centre, frame.z))
    return bool(path.to_loads(sm.Integer(1))[0].force.dot(frame.y) > 0)


def is_rigid(body: Body) -> bool:
    """Return whether a body has a frame and an inertia."""
    return isinstance(body, RigidBody)


def check_bodies(bodies: Iterable[Body]) -> tuple[Body, ...]:
    """Return bodies as a tuple."""
    bodies_, identities = tuple(bodies), set()
    for body in bodies_:
        if id(body) in identities:
            raise ValueError(
                f"`bodies` has {getattr(body, 'name', body)} more than once: its mass would count "
                "as often. Name it once."
            )
        identities.add(id(body))
        if not isinstance(body, (RigidBody, Particle)):
            raise TypeError(
                f"`bodies` must hold Particle and RigidBody objects, got {shown(body)} of type "
                f"{type(body).__name__}."
            )
        if is_rigid(body):
            _check_symmetric(body)
    return bodies_


def _check_symmetric(body: Body) -> None:
    """Refuse an inertia dyadic in one frame that is not symmetric."""
    terms = body.central_inertia.args
    # A dyadic holds the unit vectors of its frame: comparing identities is faster.
    axes = {id(axis) for axis in terms[0][1].args[0][1]} if terms else set()
    if any(id(v) not in axes for _, *vectors in terms for v in vectors):
        return
    cells = {(id(a), id(b)): size for size, a, b in terms}
    unlike = [
        (size, mirrored, a, b)
        for size, a, b in terms
        if size != (mirrored := cells.get((id(b), id(a)), sm.S.Zero))
    ]
    if not unlike:
        return
    graph = Graph()
    read = InputReader(graph, {}, ()).all
    values = numbers_of(graph, read([*(e for row in unlike for e in row[:2]), *cells.values()]))
    allowed = ROUNDED * abs(values).max(axis=1)
    for k, (size, mirrored, a, b) in enumerate(unlike):
        if (abs(values[:, 2 * k] - values[:, 2 * k + 1]) > allowed).any():
            raise ValueError(
                f"The inertia of the body {body.name} is not symmetric: it has {size} at "
                f"({a}|{b}), and {mirrored} at ({b}|{a}). Give both, as `inertia(frame, ixx, iyy, "
                "izz, ixy, iyz, izx)` does."
            )


class InputReader(SymPyReader):
    """Reads expressions; symbols other than states and time become inputs when they occur."""

    def __init__(
        self, graph: Graph, atoms: dict[AnySymbol, int], states: Sequence[TimeFunction]
    ) -> None:
        super().__init__(graph, atoms, "the bodies, loads and kinematics")
        self.states = frozenset(states)
        self.constants: list[sm.Symbol] = []
        self.specifieds: list[TimeFunction] = []
        self.second: Callable[[sm.Derivative], int | None] = lambda symbol: None

    def _leaf(self, expr: sm.Expr) -> int | None:
        if expr not in self.atoms:
            if isinstance(expr, sm.Symbol):
                self.atoms[expr] = self.graph.input("p", len(self.constants))
                self.constants.append(expr)
            elif isinstance(expr, (AppliedUndef, sm.Derivative)):
                return self._function(expr)
        return super()._leaf(expr)

    def _function(self, expr: TimeFunction) -> int:
        if isinstance(expr, sm.Derivative) and expr.expr in self.states:
            node = self.second(expr)
            if node is None:
                raise ValueError(
                    f"`{expr}` occurs in {self.what}, but of the coordinates and speeds only the "
                    "first derivatives are available. Rewrite it in terms of the speeds and their "
                    "first derivatives."
                )
            self.atoms[expr] = node
            return node
        self.atoms[expr] = node = self.graph.input("r", len(self.specifieds))
        self.specifieds.append(expr)
        return node
