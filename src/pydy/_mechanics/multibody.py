"""Bodies, loads, kinematics and constraints: what equations of motion are formed from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from pydy._mechanics.frame_tree import FrameTree
from pydy._mechanics.kinematic_constraints import DependentStates, KinematicConstraints
from pydy._mechanics.kinematic_equations import KinematicEquations
from pydy._mechanics.reader import is_rigid

if TYPE_CHECKING:
    import sympy as sm
    from sympy.physics.mechanics import Point, ReferenceFrame

    from pydy._sympy_types import Body, Load, TimeFunction


@dataclass(frozen=True, eq=False)
class Multibody:
    """Bodies, loads, kinematics and constraints, from which equations of motion are formed."""

    frame: ReferenceFrame  # the inertial frame
    bodies: tuple[Body, ...]
    loads: tuple[Load, ...]
    time: sm.Symbol
    coordinates: tuple[TimeFunction, ...]  # in the order of the states, like the speeds
    speeds: tuple[TimeFunction, ...]
    kinematics: KinematicEquations
    dependents: DependentStates
    constraints: KinematicConstraints = field(default_factory=KinematicConstraints)
    auxiliary: tuple[TimeFunction, ...] = ()  # auxiliary speeds
    # In place of bodies; the speeds are then the derivatives of the coordinates.
    lagrangian: sm.Expr | None = None
    # The potential energy of the loads, or of those that are not constant; to be verified.
    potential: sm.Expr | None = None
    activations: tuple[TimeFunction, ...] = ()  # states of musculotendons that are specifieds here
    # The properties of the bodies when they were read: SymPy lets users change them.
    snapshots: tuple[tuple[Body, tuple[Any, ...]], ...] = ()
    # The point that positions are measured from. It is selected once: SymPy's `Point.vel` sets the
    # velocity that it derives, so that later another point may be the nearest at rest.
    origin: Point | None = None

    def __post_init__(self) -> None:
        if not self.snapshots:
            snapshots = tuple((body, _snapshot(body)) for body in self.bodies)
            object.__setattr__(self, "snapshots", snapshots)
            if self.origin is None and self.frame is not None:
                centres = map(attrgetter("masscenter"), self.bodies)
                object.__setattr__(self, "origin", FrameTree.point_at_rest(self.frame, centres))

    def check_unchanged(self) -> None:
        """Refuse bodies that changed since they were read: their equations would be outdated."""
        for body, before in self.snapshots:
            names = ("mass", "inertia", "mass center", "frame", "position", "orientation")
            for name, old, new in zip(names, before, _snapshot(body), strict=True):
                if isinstance(old, dict):  # SymPy adds neighbours as it goes
                    new = {key: new.get(key) for key in old}
                if old is not new and old != new:
                    change = "" if isinstance(old, dict) else f" from {old} to {new}"
                    raise ValueError(
                        f"The {name} of the body `{body.name}` has been changed{change} since the "
                        "System was made. Its equations of motion are those from before: make a "
                        "new System, or undo the change. For values that vary, use constants."
                    )


def independent_first(body: Multibody) -> Multibody:
    """Return a copy with the dependent coordinates and speeds last, as equations are formed."""
    coordinates = _last(body.coordinates, body.dependents.coordinates)
    speeds = _last(body.speeds, body.dependents.speeds)
    if (coordinates, speeds) == (body.coordinates, body.speeds):
        return body
    kinematics = body.kinematics
    order = [body.coordinates.index(q) for q in coordinates]
    order_of_speeds = [body.speeds.index(u) for u in speeds]
    return replace(
        body,
        coordinates=coordinates,
        speeds=speeds,
        kinematics=replace(
            kinematics,
            coordinate_rates=tuple(kinematics.coordinate_rates[k] for k in order),
            speed_rates=tuple(kinematics.speed_rates[k] for k in order_of_speeds),
            coordinate_derivatives=tuple(kinematics.coordinate_derivatives[k] for k in order),
        ),
        dependents=replace(body.dependents, all_speeds=speeds),
    )


def _last(
    symbols: Sequence[TimeFunction], dependent: Sequence[TimeFunction]
) -> tuple[TimeFunction, ...]:
    """Return the symbols with the dependent ones last."""
    return (*(s for s in symbols if s not in dependent), *dependent)


def _snapshot(body: Body) -> tuple[Any, ...]:
    """Return a record of a body's properties for `Multibody.check_unchanged`."""
    point = body.masscenter
    positions = {**FrameTree.positions(point)}
    if not is_rigid(body):
        return body.mass, None, point, None, positions, {}
    orientations = {**FrameTree.orientations(body.frame)}
    return body.mass, body.inertia, point, body.frame, positions, orientations
